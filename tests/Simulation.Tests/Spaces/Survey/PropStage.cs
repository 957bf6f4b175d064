using Harvester.Capture.Spaces.Survey;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Spaces.Survey;

/// <summary>A stage on which shapes of the test are put up, one at a time, on uneven ground, turned anyhow.</summary>
internal sealed class PropStage(IReadOnlyDictionary<string, Prop> props, Pose pose) : ISurveyStage, IRayCaster
{
    private const int Handle = 77;
    private static readonly Mesh Ground = new MeshBuilder()
        .AddQuad(new(-100, -100, 0), new(100, -100, 0), new(100, 100, 0), new(-100, 100, 0), new Rgb(90, 90, 90)).Build();

    private readonly RenderScene _scene = new([new MeshInstance(Ground, pose, RayHit.World)]);
    private int _ticksToLoad = 3;

    public IRayCaster Rays => this;

    public int Standing { get; private set; }

    public List<string> PutUpModels { get; } = [];

    /// <summary>Rays until the game fails; null for never.</summary>
    public int? RaysUntilFailure { get; set; }

    public ModelLoading Load(string model)
    {
        if (!props.ContainsKey(model))
        {
            return ModelLoading.Missing;
        }

        _ticksToLoad--;
        return _ticksToLoad > 0 ? ModelLoading.Loading : ModelLoading.Loaded;
    }

    public StagedModel? PutUp(string model)
    {
        _ticksToLoad = 3;
        Prop prop = props[model];
        _scene.SetDynamic([new MeshInstance(prop.Shape, pose, Handle)]);
        Standing++;
        PutUpModels.Add(model);
        return new StagedModel(Handle, pose, prop.Shape.Min, prop.Shape.Max, prop.Bones);
    }

    public void TakeAway(int entity)
    {
        Assert.Equal(Handle, entity);
        _scene.SetDynamic([]);
        Standing--;
    }

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) =>
        RaysUntilFailure-- == 0
            ? throw new InvalidOperationException("the game is gone")
            : new SceneRayCaster(_scene).Cast(ray, maxDistance, ignoredEntity);
}
