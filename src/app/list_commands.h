// `nuno scenes` and `nuno params`.
#pragma once

namespace nuno {

// One line a scene: its name and what it shows.
int list_scenes();

// One line a parameter: name, default, range, unit, what it does. `markdown`: the text of docs/parameters.md.
int list_params(bool markdown);

}  // namespace nuno
