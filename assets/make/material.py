"""The MTL file: for each material its maps and its exponent."""


def write_mtl(path, shininess):
    """Writes a material for each name in `shininess` (its specular exponent), with the maps NAME_diffuse.png, NAME_specular.png and
    NAME_emissive.png. The factors are 1: the maps alone say how much light is reflected."""
    blocks = [
        f"newmtl {name}\nKa 0 0 0\nKd 1 1 1\nKs 1 1 1\nKe 1 1 1\nNs {exponent}\nillum 2\n"
        f"map_Kd {name}_diffuse.png\nmap_Ks {name}_specular.png\nmap_Ke {name}_emissive.png\n"
        for name, exponent in shininess.items()
    ]
    path.write_text("\n".join(blocks), encoding="ascii")
