namespace Harvester.Simulation.Rendering;

/// <summary>Processes the leaves that a ray reaches. Implemented by structs so that the call is inlined.</summary>
internal interface ILeafVisitor
{
    /// <summary>Processes the items of a leaf and shortens the ray to the nearest hit.</summary>
    /// <param name="leaf">The number of the leaf.</param>
    /// <param name="limit">The length of the ray.</param>
    void Visit(int leaf, ref double limit);
}
