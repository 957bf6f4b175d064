using Harvester.Geometry;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Quirks;

/// <summary>The shapes that rays hit if they differ from the visible ones: boxes around entities, and far vehicles left out.</summary>
internal sealed class RayShapes
{
    private const double MissesBeyond = 30;

    private readonly GameQuirks _quirks;
    private readonly int _seed;
    private readonly Dictionary<Mesh, Mesh> _boxes = [];

    public RayShapes(GameQuirks quirks, int seed, RenderScene seen)
    {
        _quirks = quirks;
        _seed = seed;
        Scene = new RenderScene(Met(seen.Static.Instances));
    }

    /// <summary>The scene against which rays are cast.</summary>
    public RenderScene Scene { get; }

    public static bool AreNeededFor(GameQuirks quirks) => quirks.RaysMeetBoxes || quirks.RayMissFraction > 0;

    /// <summary>Updates the moving shapes.</summary>
    /// <param name="moving">The visible shapes.</param>
    /// <param name="eye">The camera's position.</param>
    /// <param name="isVehicle">Whether a handle is a moving vehicle's.</param>
    /// <param name="state">Number of the world's state.</param>
    public void Show(IEnumerable<MeshInstance> moving, Vector3D eye, Predicate<int> isVehicle, long state)
    {
        List<MeshInstance> kept = [];
        foreach (MeshInstance instance in moving)
        {
            bool isFar = (instance.Pose.Position - eye).Length > MissesBeyond;
            if (!isFar || !isVehicle(instance.Handle) || !IsMissed(instance.Handle, state))
            {
                kept.Add(instance);
            }
        }

        Scene.SetDynamic(Met([.. kept]));
    }

    private bool IsMissed(int handle, long state) =>
        new Random(unchecked((((_seed * 31) + handle) * 31) + (int)state)).NextDouble() < _quirks.RayMissFraction;

    private MeshInstance[] Met(ReadOnlySpan<MeshInstance> instances)
    {
        MeshInstance[] met = instances.ToArray();
        for (int i = 0; _quirks.RaysMeetBoxes && i < met.Length; i++)
        {
            met[i] = met[i].Handle == 0 ? met[i] : met[i] with { Mesh = BoxAround(met[i].Mesh) };
        }

        return met;
    }

    private Mesh BoxAround(Mesh mesh)
    {
        if (!_boxes.TryGetValue(mesh, out Mesh? box))
        {
            _boxes[mesh] = box = new MeshBuilder().AddBox(mesh.Min, mesh.Max, default).Build();
        }

        return box;
    }
}
