using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Tests.Models;

namespace Harvester.Simulation.Tests.Faces;

/// <summary>
/// A game that shows another street in each frame: signs and traffic lights turned anyhow, cars and walls among them. Each picture is
/// drawn with the faces under numbers of their own, so it is known how many pixels of each are seen.
/// </summary>
internal sealed class StreetOfFaces : IWorld, IScreen, IPause, IClock, IRayCaster, ILights
{
    private const int FirstFaceHandle = 1_000;
    private const int FacesOfEntity = 10;
    private static readonly ImageSize Size = new(640, 480);
    private static readonly CameraState Camera = new(new Pose(new Vector3D(0, 0, 1.6), Axes.Identity), 50, 0.15, 4.0 / 3);
    private static readonly Mesh Ground = new MeshBuilder()
        .AddQuad(new(-300, -300, 0), new(300, -300, 0), new(300, 300, 0), new(-300, 300, 0), new Rgb(96, 98, 92), Surface.Ground)
        .Build();

    private static readonly RenderCamera Eye = new(
        Camera.Pose,
        Camera.VerticalFovDegrees,
        Camera.WindowAspect,
        Camera.NearClip,
        Size.Width,
        Size.Height
    );

    private readonly Renderer _renderer = new();
    private readonly RenderTarget _picture = new(Size.Width, Size.Height);
    private readonly RenderScene _drawn = Scene();
    private readonly RenderScene _hit = Scene();
    private readonly SceneRayCaster _rays;
    private readonly bool _setsLights;
    private List<(EntityState State, Model Model, int Variant)> _entities = [];
    private int _seed;

    public StreetOfFaces(int firstSeed, bool setsLights = false)
    {
        _seed = firstSeed;
        _setsLights = setsLights;
        _rays = new SceneRayCaster(_hit);
        Build();
    }

    public static HarvestOptions Options(int frames) =>
        new()
        {
            Image = Size,
            MaxFrames = frames,
            RateHz = 60,
            MaxPictureLagTicks = 0,
            ProbeLag = false,
            MaxCalibrationErrorPixels = null,
            Faces = ModelFaces.Table,
        };

    public GamePorts Ports => new(this, this, this, this, this) { Lights = _setsLights ? this : null };

    public long GameFrame { get; private set; }

    public double TimeSeconds => GameFrame / 60.0;

    public double Milliseconds => GameFrame * 1000 / 60.0;

    /// <summary>The faces of the present street.</summary>
    public IEnumerable<TrueFace> Faces =>
        from entity in _entities
        where entity.Model.Class is ObjectClass.Sign or ObjectClass.TrafficLight
        from number in Enumerable.Range(0, FaceParts.Split(entity.Model, entity.Variant).Count - 1)
        let pose = entity.State.Pose
        let face = ModelFaces.Table.Of(entity.Model.Name)[number]
        select new TrueFace(
            face.CuboidAt(pose).Centre,
            pose.Axes.Forward.Dot(pose.ToWorld(face.BackLowerRight) - Camera.Pose.Position) > 0,
            _picture.Handles.Count(handle => handle == FaceHandle(entity.State.Handle, number)),
            entity.Model.Class == ObjectClass.TrafficLight ? (LightState)(1 + entity.Variant) : null,
            new Lazy<int>(() => PixelsAlone(entity.State, entity.Model, entity.Variant, number))
        );

    /// <summary>Harvests streets and gives each label with its truth.</summary>
    public static IEnumerable<(FrameLabel Label, IReadOnlyList<TrueFace> Faces)> Harvest(int frames, int firstSeed, bool setsLights = false)
    {
        var game = new StreetOfFaces(firstSeed, setsLights);
        var sink = new TruthSink(game);
        using var session = new HarvestSession(Options(frames), game.Ports, sink);
        while (!session.Step().IsOver)
        {
            game.GameFrame++;
        }

        Assert.Null(session.Fault);
        return sink.Frames;
    }

    public CameraState ReadCamera() => Camera;

    public EgoState ReadEgo() => new(RayHit.World, "blista", Camera.Pose, Vector3D.Zero);

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) => [.. _entities.Select(entity => entity.State)];

    public EnvironmentState ReadEnvironment() => new("clear", TimeSpan.FromHours(12));

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => _rays.Cast(ray, maxDistance, ignoredEntity);

    public LightState? SetStateOf(int entity, long gameFrame) =>
        (LightState)(1 + _entities.Single(own => own.State.Handle == entity).Variant);

    public FreezeMethod Method { get; set; }

    public void Freeze() { }

    public void Unfreeze() { }

    public GrabResult Grab(PixelBuffer target)
    {
        _renderer.Render(_drawn, Eye, _picture);
        Buffer.BlockCopy(_picture.Colour, 0, target.Bytes, 0, target.Bytes.Length);
        return GrabResult.Good;
    }

    public void Next()
    {
        _seed++;
        Build();
    }

    /// <summary>Pixels of a face where nothing but its own model is in the picture.</summary>
    private static int PixelsAlone(EntityState state, Model model, int variant, int face)
    {
        RenderScene alone = Scene();
        alone.SetDynamic(Drawn(state, model, variant));
        var picture = new RenderTarget(Size.Width, Size.Height);
        new Renderer().Render(alone, Eye, picture);
        return picture.Handles.Count(handle => handle == FaceHandle(state.Handle, face));
    }

    private static int FaceHandle(int entity, int face) => FirstFaceHandle + (entity * FacesOfEntity) + face;

    private static RenderScene Scene() => new([new MeshInstance(Ground, new Pose(Vector3D.Zero, Axes.Identity), RayHit.World)]);

    private void Build()
    {
        var random = new Random(_seed);
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        T OneOf<T>(IReadOnlyList<T> list) => list[random.Next(list.Count)];
        ModelCatalogue catalogue = ModelCatalogueTests.Catalogue;
        var entities = new List<(EntityState, Model, int)>();
        for (int handle = 1; handle <= 24; handle++)
        {
            Model model = (handle % 3) switch
            {
                0 => OneOf(catalogue.Vehicles),
                1 => OneOf(catalogue.Signs),
                _ => OneOf(catalogue.TrafficLights),
            };
            double ahead = Between(5, 70);
            var position = new Vector3D(
                Between(-0.5, 0.5) * ahead,
                ahead,
                model.Class is ObjectClass.Sign or ObjectClass.TrafficLight ? 0 : -model.Min.Z
            );

            // Two in three look at the camera more or less, the others anywhere.
            double heading = random.Next(3) < 2 ? Between(-60, 60) : Between(0, 360);
            var state = new EntityState(
                handle,
                model.Class,
                model.Name,
                new Pose(position, Axes.FromHeading(heading)),
                model.Min,
                model.Max,
                Vector3D.Zero
            );
            entities.Add((state, model, random.Next(3)));
        }

        _entities = entities;
        string weather = OneOf([.. WeatherNames.All.Where(name => name is not ("foggy" or "blizzard"))]);
        var lighting = Weather.LightingOf(weather, 121, TimeSpan.FromHours(Between(0, 24)));
        _drawn.Lighting = lighting;
        _hit.SetDynamic(
            _entities.Select(entity => new MeshInstance(entity.Model.Variant(entity.Variant), entity.State.Pose, entity.State.Handle))
        );
        _drawn.SetDynamic(_entities.SelectMany(entity => Drawn(entity.State, entity.Model, entity.Variant)));
    }

    private static IEnumerable<MeshInstance> Drawn(EntityState state, Model model, int variant)
    {
        if (model.Class is not (ObjectClass.Sign or ObjectClass.TrafficLight))
        {
            return [new MeshInstance(model.Variant(variant), state.Pose, state.Handle)];
        }

        IReadOnlyList<Mesh> parts = FaceParts.Split(model, variant);
        return parts.Select(
            (part, i) => new MeshInstance(part, state.Pose, i < parts.Count - 1 ? FaceHandle(state.Handle, i) : state.Handle)
        );
    }
}
