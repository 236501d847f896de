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
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/**
 * Created by Fabian on 16.09.2017.
 */
class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram
    //private val meshHaus: Mesh
    //private val meshSphere: Mesh

    private val groundRenderable: Renderable
    private val bikeRenderable: Renderable
    private val camera: TronCamera

    private val bikePointLight: PointLight
    private val frontSpotLight: SpotLight
    private val eckLicht1: PointLight
    private val eckLicht2: PointLight
    private val eckLicht3: PointLight
    private val eckLicht4: PointLight

    private var bikeFarbe = Vector3f(1.0f, 1.0f, 1.0f)
    private val bodenFarbe = Vector3f(0.0f, 1.0f, 0.0f)

    private var ersteMausBewegung = true
    private var oldMousePosX = 0.0
    private var oldMousePosY = 0.0

    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        //glEnable(GL_CULL_FACE); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Blatt 1: Haus
        /*val vertices = floatArrayOf(
            -0.5f, -0.5f, 0.0f, 0.0f, 0.0f, 1.0f,
             0.5f, -0.5f, 0.0f, 0.0f, 0.0f, 1.0f
        )*/

        // Blatt 2: Ground
        val stride = 8 * 4
        val attrPos = VertexAttribute(3, stride, 0)
        val attrTC = VertexAttribute(2, stride, 3 * 4)
        val attrNorm = VertexAttribute(3, stride, 5 * 4)
        val vertexAttributes = arrayOf(attrPos, attrTC, attrNorm)

        val groundObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        println("Ground: " + groundObj.indexData.size / 3 + " Dreiecke")

        // Blatt 3: Material
        val texEmit = Texture2D("assets/textures/ground_emit.png", true)
        val texDiff = Texture2D("assets/textures/ground_diff.png", true)
        val texSpec = Texture2D("assets/textures/ground_spec.png", true)
        texEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(texDiff, texEmit, texSpec, 60.0f, Vector2f(64.0f, 64.0f))
        val groundMesh = Mesh(groundObj.vertexData, groundObj.indexData, vertexAttributes, groundMaterial)
        groundRenderable = Renderable(mutableListOf(groundMesh))

        bikeRenderable = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)!!
        bikeRenderable.scaleLocal(Vector3f(0.8f))

        camera = TronCamera()
        camera.parent = bikeRenderable
        camera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))

        // Blatt 4: Lichter
        bikePointLight = PointLight(Vector3f(0.0f, 1.6f, 0.4f), Vector3f(1.0f, 1.0f, 1.0f))
        bikePointLight.parent = bikeRenderable

        frontSpotLight = SpotLight(Vector3f(0.0f, 1.1f, -1.7f), Vector3f(3.0f, 3.0f, 3.0f), Vector2f(15.0f, 28.0f))
        frontSpotLight.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        frontSpotLight.parent = bikeRenderable

        eckLicht1 = PointLight(Vector3f(-12.0f, 1.2f, -12.0f), Vector3f(1.0f, 0.1f, 0.1f), 7.0f)
        eckLicht2 = PointLight(Vector3f(12.0f, 1.2f, -12.0f), Vector3f(0.1f, 0.2f, 1.0f), 7.0f)
        eckLicht3 = PointLight(Vector3f(-12.0f, 1.2f, 12.0f), Vector3f(1.0f, 0.9f, 0.1f), 7.0f)
        eckLicht4 = PointLight(Vector3f(12.0f, 1.2f, 12.0f), Vector3f(1.0f, 0.1f, 1.0f), 7.0f)

        //println(bikePointLight.getWorldPosition())
        //println(frontSpotLight.getWorldZAxis())
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        // Farbe von Bike und Punktlicht
        bikeFarbe = Vector3f(abs(sin(t)), abs(sin(t * 0.5f + 0.7f)), abs(cos(t * 0.8f)))
        bikePointLight.lightCol = bikeFarbe

        staticShader.use()
        camera.bind(staticShader)

        bikePointLight.bind(staticShader, "bike")
        frontSpotLight.bind(staticShader, "spot", camera.getCalculateViewMatrix())
        eckLicht1.bind(staticShader, "ecke1")
        eckLicht2.bind(staticShader, "ecke2")
        eckLicht3.bind(staticShader, "ecke3")
        eckLicht4.bind(staticShader, "ecke4")

        staticShader.setUniform("farbe", bodenFarbe)
        groundRenderable.render(staticShader)
        staticShader.setUniform("farbe", bikeFarbe)
        bikeRenderable.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            bikeRenderable.translateLocal(Vector3f(0.0f, 0.0f, -5.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) {
                bikeRenderable.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                bikeRenderable.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            }
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            bikeRenderable.translateLocal(Vector3f(0.0f, 0.0f, 5.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) {
                bikeRenderable.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                bikeRenderable.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            }
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (ersteMausBewegung) {
            oldMousePosX = xpos
            oldMousePosY = ypos
            ersteMausBewegung = false
        }
        val dx = oldMousePosX - xpos
        val dy = oldMousePosY - ypos
        oldMousePosX = xpos
        oldMousePosY = ypos
        //println("dx $dx dy $dy")
        camera.rotateAroundPoint(0.0f, (dx * 0.002).toFloat(), 0.0f, Vector3f(0.0f))
    }

    fun cleanup() {
        groundRenderable.cleanup()
        bikeRenderable.cleanup()
        staticShader.cleanup()
    }
}
