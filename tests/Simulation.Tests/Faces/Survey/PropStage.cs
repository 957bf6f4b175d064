using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Play.Surveys.Faces;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Faces.Survey;

/// <summary>A stage on which shapes of the test are put up, one at a time, on uneven ground, turned anyhow.</summary>
internal sealed class PropStage(IReadOnlyDictionary<string, Prop> props, Pose pose) : ISurveyStage, IRayCaster
{
    private const int Handle = 77;
    private static readonly Mesh Ground = new MeshBuilder()
        .AddQuad(new(-100, -100, 0), new(100, -100, 0), new(100, 100, 0), new(-100, 100, 0), new Rgb(90, 90, 90))
        .Build();

    private readonly RenderScene _scene = new([new MeshInstance(Ground, pose, RayHit.World)]);
    private readonly Dictionary<string, int> _ticksToLoad = [];

    public IRayCaster Rays => this;

    public int Standing { get; private set; }

    public List<string> PutUpModels { get; } = [];

    public int RaysCast { get; private set; }

    /// <summary>Models that were requested from the game and may not be unloaded.</summary>
    public IEnumerable<string> Asked => _ticksToLoad.Keys;

    /// <summary>Rays until the game fails; null for never.</summary>
    public int? RaysUntilFailure { get; set; }

    public ModelLoading Load(string model)
    {
        if (!props.ContainsKey(model))
        {
            return ModelLoading.Missing;
        }

        int ticks = _ticksToLoad.GetValueOrDefault(model, 3) - 1;
        _ticksToLoad[model] = ticks;
        return ticks > 0 ? ModelLoading.Loading : ModelLoading.Loaded;
    }

    public void Release(string model) => _ticksToLoad.Remove(model);

    public int PutUp(string model)
    {
        Assert.Equal(0, Standing);
        Assert.True(_ticksToLoad[model] <= 0);
        _scene.SetDynamic([new MeshInstance(props[model].Shape, pose, Handle)]);
        Standing++;
        PutUpModels.Add(model);
        return Handle;
    }

    public void Hold(int entity) => Assert.Equal(Handle, entity);

    public StagedModel Read(int entity, string model)
    {
        Prop prop = props[model];
        return new StagedModel(entity, pose, prop.Shape.Min, prop.Shape.Max, prop.Bones);
    }

    public bool IsStanding(int entity) => Standing > 0;

    public void TakeAway(int entity)
    {
        Assert.Equal(Handle, entity);
        _scene.SetDynamic([]);
        Standing--;
    }

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        RaysCast++;
        return RaysUntilFailure == RaysCast
            ? throw new InvalidOperationException("the game is gone")
            : new SceneRayCaster(_scene).Cast(ray, maxDistance, ignoredEntity);
    }
}
