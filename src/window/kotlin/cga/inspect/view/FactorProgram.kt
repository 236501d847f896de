package cga.inspect.view

import cga.exercise.components.shader.ShaderProgram

/**
 * `factors.frag`, which shows one factor of the formula. Compiled only when such a view is first asked for; a uniform that it lacks is the
 * scene's business.
 */
internal class FactorProgram(
    vertexPath: String,
    constants: Map<String, Int>,
) : ShaderProgram(vertexPath, "shaders/inspect/factors.frag", constants) {
    private var isUsed = false

    override fun use() {
        isUsed = true
        super.use()
    }

    override fun reload() {
        if (isUsed) super.reload()
    }

    override fun warn(message: String) = Unit
}
