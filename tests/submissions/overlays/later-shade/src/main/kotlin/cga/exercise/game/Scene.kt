package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

/**
 * Created by Fabian on 16.09.2017.
 */
class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground: Renderable
    private val bike: Renderable

    private val groundColor = Vector3f(0f, 1f, 0f)
    private var bikeColor = Vector3f(1f, 1f, 1f)

    //lights
    private val bikePointLight: PointLight
    private val bikeSpotLight: SpotLight
    private val cornerLights = ArrayList<PointLight>()

    //camera
    private val camera: TronCamera
    private var oldMouseX = 0.0
    private var firstMouseMove = true

    //scene setup
    init {
        //region ground
        val groundObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * 4
        val vertexAttributes = arrayOf(
            VertexAttribute(3, stride, 0),
            VertexAttribute(2, stride, 3 * 4),
            VertexAttribute(3, stride, 5 * 4)
        )
        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        groundDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        groundEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundSpec = Texture2D("assets/textures/ground_spec.png", true)
        groundSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(groundDiff, groundEmit, groundSpec, 60f, Vector2f(64f, 64f))
        ground = Renderable(mutableListOf(Mesh(groundObj.vertexData, groundObj.indexData, vertexAttributes, groundMaterial)))
        //endregion

        //region bike
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)
            ?: throw IllegalArgumentException("loading failed")
        bike.scale(Vector3f(0.8f, 0.8f, 0.8f))
        //endregion

        //region camera
        camera = TronCamera()
        camera.parent = bike
        camera.rotate(Math.toRadians(-32f), 0f, 0f)
        camera.translate(Vector3f(0f, 0f, 4.2f))
        //endregion

        //region lights
        bikePointLight = PointLight(Vector3f(0f, 2f, 0f), Vector3f(1f, 1f, 1f), "bikeLight")
        bikePointLight.parent = bike

        bikeSpotLight = SpotLight(Vector3f(0f, 1f, -1.9f), Vector3f(14f, 14f, 12f), "frontLight", 16f, 28f)
        bikeSpotLight.parent = bike
        bikeSpotLight.rotate(Math.toRadians(-12f), 0f, 0f)

        cornerLights.add(PointLight(Vector3f(18f, 1.8f, 18f), Vector3f(18f, 1f, 4f), "cornerLight[0]"))
        cornerLights.add(PointLight(Vector3f(-18f, 1.8f, 18f), Vector3f(1f, 16f, 5f), "cornerLight[1]"))
        cornerLights.add(PointLight(Vector3f(-18f, 1.8f, -18f), Vector3f(3f, 4f, 20f), "cornerLight[2]"))
        cornerLights.add(PointLight(Vector3f(18f, 1.8f, -18f), Vector3f(17f, 14f, 1f), "cornerLight[3]"))
        //endregion

        //initial opengl state
        glClearColor(0f, 0f, 0f, 1f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        bikeColor = Vector3f(Math.abs(Math.sin(t + 0.5f)), Math.abs(Math.sin(t * 0.7f + 1f)), Math.abs(Math.sin(t * 0.4f + 2f)))
        bikePointLight.lightCol = bikeColor

        staticShader.use()
        camera.bind(staticShader)

        //lights
        bikePointLight.bind(staticShader)
        bikeSpotLight.bind(staticShader, camera.getCalculateViewMatrix())
        cornerLights.forEach { it.bind(staticShader) }

        //objects
        staticShader.setUniform("emitColor", groundColor)
        ground.render(staticShader)

        staticShader.setUniform("emitColor", bikeColor)
        bike.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            bike.translate(Vector3f(0f, 0f, -6f * dt))
            if (window.getKeyState(GLFW_KEY_A)) bike.rotate(0f, 1.6f * dt, 0f)
            if (window.getKeyState(GLFW_KEY_D)) bike.rotate(0f, -1.6f * dt, 0f)
        } else if (window.getKeyState(GLFW_KEY_S)) {
            bike.translate(Vector3f(0f, 0f, 6f * dt))
            if (window.getKeyState(GLFW_KEY_A)) bike.rotate(0f, -1.6f * dt, 0f)
            if (window.getKeyState(GLFW_KEY_D)) bike.rotate(0f, 1.6f * dt, 0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (!firstMouseMove) {
            val yaw = (oldMouseX - xpos).toFloat() * 0.002f
            camera.rotateAroundPoint(0f, yaw, 0f, Vector3f(0f, 0f, 0f))
        }
        oldMouseX = xpos
        firstMouseMove = false
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        staticShader.cleanup()
    }
}
