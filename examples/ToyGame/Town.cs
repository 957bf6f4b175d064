using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;

namespace ToyGame;

/// <summary>
/// The smallest game that can be harvested: a flat ground, two boxes that count as cars, and a camera on a third car. World axes are x
/// east, y north, z up, in metres.
/// </summary>
internal sealed class Town : IWorld, IPause
{
    private const double SecondsPerTick = 1 / 60.0;
    private const double VerticalFovDegrees = 50;
    private const double NearClip = 0.1;
    private const double MetresPerSecond = 5;

    /// <summary>The size of the picture, pixels.</summary>
    public static ImageSize Image { get; } = new(320, 240);

    private static readonly Vector3D CarMin = new(-0.9, -2.2, -0.6);
    private static readonly Vector3D CarMax = new(0.9, 2.2, 0.8);

    private readonly BoxRays _rays;
    private bool _isFrozen;

    public Town()
    {
        _rays = new BoxRays(Entities);
        Ports = new GamePorts(this, _rays, new RayScreen(this, _rays), this, new PlayerClock());
    }

    /// <summary>What a harvest needs of this game.</summary>
    public GamePorts Ports { get; }

    /// <inheritdoc/>
    public long GameFrame { get; private set; }

    /// <inheritdoc/>
    public double TimeSeconds { get; private set; }

    /// <inheritdoc/>
    public FreezeMethod Method { get; set; }

    /// <summary>A parked car ahead, and one that drives towards the camera.</summary>
    private IReadOnlyList<EntityState> Entities() =>
        [
            Car(handle: 2, "parked", new Vector3D(3, 14, 0.6), metresPerSecond: 0),
            Car(handle: 3, "oncoming", new Vector3D(-3, 30 - (MetresPerSecond * TimeSeconds), 0.6), -MetresPerSecond),
        ];

    /// <summary>Lets the time of a tick pass; a frozen world only counts the frame.</summary>
    public void Tick()
    {
        GameFrame++;
        TimeSeconds += _isFrozen ? 0 : SecondsPerTick;
    }

    public void Freeze() => _isFrozen = true;

    public void Unfreeze() => _isFrozen = false;

    public CameraState ReadCamera() =>
        new(new Pose(new Vector3D(0, 0, 1.4), Axes.Identity), VerticalFovDegrees, NearClip, (double)Image.Width / Image.Height);

    public EgoState ReadEgo() =>
        new(Handle: 1, "ego", new Pose(new Vector3D(0, -1, 0.6), Axes.Identity), Vector3D.Zero) { ModelMin = CarMin, ModelMax = CarMax };

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) =>
        [.. Entities().Where(entity => (entity.Pose.Position - centre).Length <= range)];

    public EnvironmentState ReadEnvironment() => new("clear", TimeSpan.FromHours(12));

    private static EntityState Car(int handle, string model, Vector3D position, double metresPerSecond) =>
        new(handle, ObjectClass.Car, model, new Pose(position, Axes.Identity), CarMin, CarMax, new Vector3D(0, metresPerSecond, 0));
}
