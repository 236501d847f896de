package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.*
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

/**
 * Created 29.03.2023.
 */
class Scene(private val window: GameWindow) {
  private val staticShader: ShaderProgram

  private val ground: Renderable
  private val motorcycle: Renderable

  private val camera = TronCamera()

  private val pointLight: PointLight
  private val frontSpotLight: SpotLight
  private val worldLights = mutableListOf<PointLight>()

  private var lastX: Double? = null

  //scene setup
  init {
    staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    //initial opengl state
    glClearColor(0f, 0f, 0f, 1f); GLError.checkThrow()
    glEnable(GL_CULL_FACE); GLError.checkThrow()
    glFrontFace(GL_CCW); GLError.checkThrow()
    glCullFace(GL_BACK); GLError.checkThrow()
    glEnable(GL_DEPTH_TEST); GLError.checkThrow()
    glDepthFunc(GL_LESS); GLError.checkThrow()

    //region ground
    val texDiff = Texture2D("assets/textures/ground_diff.png", true)
    val texEmit = Texture2D("assets/textures/ground_emit.png", true)
    val texSpec = Texture2D("assets/textures/ground_spec.png", true)
    for (t in arrayOf(texDiff, texEmit, texSpec)) t.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)

    val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
    val stride = 8 * 4
    val attrPos = VertexAttribute(3, stride, 0)
    val attrTC = VertexAttribute(2, stride, 3 * 4)
    val attrNorm = VertexAttribute(3, stride, 5 * 4)
    val groundMesh = Mesh(
      obj.vertexData, obj.indexData, arrayOf(attrPos, attrTC, attrNorm),
      Material(texDiff, texEmit, texSpec, 60f, Vector2f(64f, 64f))
    )
    ground = Renderable(mutableListOf(groundMesh))
    ground.emissionColor = Vector3f(0f, 1f, 0f)
    //endregion

    //region motorcycle
    motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)
      ?: throw IllegalArgumentException("Could not load the model")
    motorcycle.scale(Vector3f(0.8f, 0.8f, 0.8f))
    //endregion

    //region camera
    camera.parent = motorcycle
    camera.rotate(toRadians(-35f), 0f, 0f)
    camera.translate(Vector3f(0f, 0f, 4f))
    //endregion

    //region lights
    pointLight = PointLight(Vector3f(0f, 2f, 0f), Vector3f(1f), 0)
    pointLight.parent = motorcycle

    frontSpotLight = SpotLight(Vector3f(0f, 1f, -2f), Vector3f(15f, 15f, 15f), toRadians(15f), toRadians(27f))
    frontSpotLight.rotate(toRadians(-10f), 0f, 0f)
    frontSpotLight.parent = motorcycle

    worldLights.add(PointLight(Vector3f(20f, 2f, 20f), Vector3f(20f, 2f, 2f), 1))
    worldLights.add(PointLight(Vector3f(-20f, 2f, 20f), Vector3f(2f, 2f, 20f), 2))
    worldLights.add(PointLight(Vector3f(-20f, 2f, -20f), Vector3f(20f, 20f, 2f), 3))
    worldLights.add(PointLight(Vector3f(20f, 2f, -20f), Vector3f(2f, 20f, 20f), 4))
    //endregion
  }

  fun render(dt: Float, t: Float) {
    glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

    val pulse = Vector3f((sin(t) + 1f) / 2f, (sin(t * 2f) + 1f) / 2f, (sin(t * 3f) + 1f) / 2f)
    pointLight.color = pulse
    motorcycle.emissionColor = pulse

    staticShader.use()
    camera.bind(staticShader)
    pointLight.bind(staticShader)
    frontSpotLight.bind(staticShader, camera.getCalculateViewMatrix())
    worldLights.forEach { it.bind(staticShader) }

    motorcycle.render(staticShader)
    ground.render(staticShader)
  }

  fun update(dt: Float, t: Float) {
    if (window.getKeyState(GLFW_KEY_W)) {
      motorcycle.translate(Vector3f(0f, 0f, -5f * dt))
      if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotate(0f, 1.5f * dt, 0f)
      if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotate(0f, -1.5f * dt, 0f)
    }
    if (window.getKeyState(GLFW_KEY_S)) {
      motorcycle.translate(Vector3f(0f, 0f, 3f * dt))
      if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotate(0f, -1.5f * dt, 0f)
      if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotate(0f, 1.5f * dt, 0f)
    }
  }

  fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

  fun onMouseMove(xpos: Double, ypos: Double) {
    val old = lastX ?: xpos
    val deltaX = (xpos - old).toFloat()
    camera.rotateAroundPoint(0f, -deltaX * 0.002f, 0f, Vector3f())
    lastX = xpos
  }

  fun cleanup() {
    ground.cleanup()
    motorcycle.cleanup()
    staticShader.cleanup()
  }
}
