namespace Harvester.Simulation.Rendering;

/// <summary>An instance whose box may be in view.</summary>
/// <param name="Instance">The instance.</param>
/// <param name="Depth">The least depth of its box, metres.</param>
/// <param name="Number">Its number among those found; of two at the same depth the first found is drawn first.</param>
internal readonly record struct SeenInstance(MeshInstance Instance, double Depth, int Number) : IComparable<SeenInstance>
{
    public int CompareTo(SeenInstance other)
    {
        int byDepth = Depth.CompareTo(other.Depth);
        return byDepth != 0 ? byDepth : Number.CompareTo(other.Number);
    }
}
