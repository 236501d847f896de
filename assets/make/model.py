"""The last step of a script that makes a model."""

from check import check_model
from mesh import write_obj


def save_model(path, library, parts, low, high, triangles, closed=True):
    """Writes the OBJ file under a temporary name, checks it as `check_model` does, and only then gives it its name."""
    draft = path.with_name(path.name + ".part")
    write_obj(draft, library, parts, f"CGA Lights: made by make_{path.stem}.py. MIT licence.")
    count = check_model(draft, triangles, low, high, closed)
    draft.replace(path)
    print(f"{path.name}: {len(parts)} parts, {count} triangles")
