using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Calibration;

/// <summary>A standing camera in a yard of boxes, rendered with a lens of its own; the picture shown may be some ticks old.</summary>
internal sealed class RenderedGame : IWorld, IRayCaster, IScreen, IPause, IClock, IMarkers
{
    private const double TickSeconds = 1 / 60.0;
    private static readonly Pose CameraPose = new(new Vector3D(1200, -340, 31.3), Axes.FromEuler(new EulerAngles(-2, 1, 77)));
    private readonly Renderer _renderer = new();
    private readonly RenderScene _scene;
    private readonly List<IReadOnlyList<PlannedMarker>> _history =
    [
        [],
    ];
    private IReadOnlyList<PlannedMarker> _markers = [];
    private int _shows;

    /// <summary>Makes a game.</summary>
    /// <param name="nearThings">Posts close to the camera, which hide some markers.</param>
    public RenderedGame(bool nearThings = false)
    {
        var random = new Random(1);
        var yard = new MeshBuilder().AddBox(new(-300, -300, -1), new(300, 300, 0), new Rgb(90, 95, 90), Surface.Ground);
        for (int i = 0; i < 150; i++)
        {
            var corner = new Vector3D((random.NextDouble() * 160) - 80, 6 + (random.NextDouble() * 80), 0);
            yard.AddBox(
                corner,
                corner + new Vector3D(3, 3, 1 + (8 * random.NextDouble())),
                new Rgb((byte)random.Next(256), (byte)random.Next(256), (byte)random.Next(256))
            );
        }

        for (int i = 0; nearThings && i < 4; i++)
        {
            yard.AddBox(new((0.3 * i) - 0.5, 0.7, 0), new((0.3 * i) - 0.48, 0.72, 3), new Rgb(40, 40, 40));
        }

        // The yard turns with the camera's heading, its ground 1.3 m below the camera.
        var ground = new Pose(CameraPose.Position - new Vector3D(0, 0, 1.3), Axes.FromEuler(new EulerAngles(0, 0, 77)));
        _scene = new RenderScene([new MeshInstance(yard.Build(), ground, 0)]);
    }

    public GamePorts Ports => new(this, this, this, this, this, this);

    public double VerticalFovDegrees { get; init; } = 50;

    public double WindowAspect { get; init; } = 4.0 / 3;

    /// <summary>The aspect ratio that the picture is rendered with; null for the one that is reported.</summary>
    public double? RenderedAspect { get; init; }

    /// <summary>Offset of the markers from their requested positions, metres, world, from a call on.</summary>
    public Vector3D MarkerShift { get; init; }

    /// <summary>The call from which on markers are shifted, from 1.</summary>
    public int MarkerShiftFromShow { get; init; }

    public RenderLens Lens { get; init; } = RenderLens.None;

    public Lighting Lighting
    {
        get => _scene.Lighting;
        init => _scene.Lighting = value;
    }

    /// <summary>Ticks by which the picture is behind.</summary>
    public int PictureLag { get; init; }

    /// <summary>Whether rain falls elsewhere in every picture.</summary>
    public bool RainMoves { get; init; }

    /// <summary>Metres that the camera creeps to the right in a tick.</summary>
    public double Creep { get; init; }

    /// <summary>How many of the markers something hides.</summary>
    public int HiddenMarkers { get; init; }

    public string? Refusal { get; set; }

    public bool IsFrozen { get; private set; }

    public bool ShowsMarkers => _markers.Count > 0;

    public long GameFrame { get; private set; }

    public double TimeSeconds { get; private set; }

    public double Milliseconds => 1000 * GameFrame * TickSeconds;

    public void Tick()
    {
        GameFrame++;
        TimeSeconds += IsFrozen ? 0 : TickSeconds;
        _history.Add(_markers);
    }

    public CameraState ReadCamera()
    {
        Pose pose = CameraPose with { Position = CameraPose.ToWorld(new Vector3D(Creep * GameFrame, 0, 0)) };
        return new CameraState(pose, VerticalFovDegrees, 0.1, WindowAspect);
    }

    public EgoState ReadEgo() => new(7, "blista", CameraPose, Vector3D.Zero);

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) => [];

    public EnvironmentState ReadEnvironment() => new("clear", TimeSpan.FromHours(12));

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => null;

    public FreezeMethod Method { get; set; }

    public void Freeze() => IsFrozen = true;

    public void Unfreeze() => IsFrozen = false;

    public void Show(IReadOnlyList<PlannedMarker> markers)
    {
        _shows++;
        Vector3D shift = MarkerShiftFromShow > 0 && _shows >= MarkerShiftFromShow ? MarkerShift : Vector3D.Zero;
        _markers = [.. markers.Select(marker => marker with { Centre = marker.Centre + shift })];
    }

    public void Clear() => _markers = [];

    public GrabResult Grab(PixelBuffer target)
    {
        if (RainMoves)
        {
            _scene.Lighting = _scene.Lighting with { PrecipitationSeed = (int)GameFrame };
        }

        _scene.SetDynamic(_history[Math.Max(0, _history.Count - 1 - PictureLag)].Skip(HiddenMarkers).Select(MarkerModel.Of));
        var camera = new RenderCamera(
            ReadCamera().Pose,
            VerticalFovDegrees,
            RenderedAspect ?? WindowAspect,
            0.1,
            target.Size.Width,
            target.Size.Height
        )
        {
            Lens = Lens,
        };
        var picture = new RenderTarget(target.Size.Width, target.Size.Height);
        _renderer.Render(_scene, camera, picture);
        picture.Colour.CopyTo(target.Bytes, 0);
        return Refusal is null ? GrabResult.Good : GrabResult.Refused(Refusal);
    }
}
