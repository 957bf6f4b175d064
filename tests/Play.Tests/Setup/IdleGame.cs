using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;
using Harvester.Play.Plans;
using Harvester.Play.Setup;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;

namespace Harvester.Play.Tests.Setup;

/// <summary>A game in which the player sits in a car and nothing happens.</summary>
internal sealed class IdleGame : IGameAdapters
{
    private static readonly Dictionary<string, object> Answers = new()
    {
        ["OfPlayer"] = 7,
        ["Exists"] = true,
        ["Make"] = 1,
    };

    /// <summary>The members of ports that were called.</summary>
    public List<string> CalledMembers { get; } = [];

    public IDisplay Display => Port<IDisplay>();

    public IHudSwitch Hud => Port<IHudSwitch>();

    public GameTime Time { get; } = new(static (_, _) => { }, static () => 0);

    public ISurfaceRays Rays => Port<ISurfaceRays>();

    public ICallCounter Calls => Port<ICallCounter>();

    public ReadingRecord Reading { get; } = new();

    public IVehicles Vehicles => Port<IVehicles>();

    public IModels Models => Port<IModels>();

    public ICameras Cameras => Port<ICameras>();

    public IShownEntities ShownEntities => Port<IShownEntities>();

    public ICarControls Controls => Port<ICarControls>();

    public ITrafficLights TrafficLights => Port<ITrafficLights>();

    public IRoadSource Roads => Port<IRoadSource>();

    public ITrialGame Trials => Port<ITrialGame>();

    public IActorGame Actors => Port<IActorGame>();

    public ISurveyStage Stage => Port<ISurveyStage>();

    public IScreen Screen => Port<IScreen>();

    public Vector3D PlayerPosition => Vector3D.Zero;

    public GameScene SceneAround(CameraMount mount, Func<FaceTable> faces, Func<bool> looksAround) =>
        new(Port<IWorld>(), Port<IProps>(), Port<ISightReader>());

    private T Port<T>()
        where T : class => IdlePort.Of<T>(CalledMembers, Answers);
}
