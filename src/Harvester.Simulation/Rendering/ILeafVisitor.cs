namespace Harvester.Simulation.Rendering;

/// <summary>Processes the items of a leaf that a ray reaches. Implemented by structs so that the call is inlined.</summary>
internal interface ILeafVisitor
{
    /// <summary>Processes items [first, first + count) of the hierarchy's order and shortens the ray to the nearest hit.</summary>
    void Visit(int first, int count, ref double limit);
}
