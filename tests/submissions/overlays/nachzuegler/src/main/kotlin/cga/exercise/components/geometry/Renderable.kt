package cga.exercise.components.geometry

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {
    // render steht jetzt in der Scene wegen mv
    //fun render(shaderProgram: ShaderProgram) {
    //    shaderProgram.setUniform("model_matrix", getWorldModelMatrix(), false)
    //    for (m in meshes) m.render(shaderProgram)
    //}
}
