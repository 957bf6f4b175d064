namespace Harvester.Simulation.Rendering;

/// <summary>The triangles of all chunks, by the numbers that pixels store.</summary>
internal sealed class ScreenTriangles(List<TriangleChunk> chunks)
{
    /// <summary>The number of a pixel that shows no triangle.</summary>
    public const int Nothing = -1;

    public ref readonly ScreenTriangle this[int id] => ref chunks[id >> TriangleChunk.IndexBits][id & ((1 << TriangleChunk.IndexBits) - 1)];

    public static int IdOf(int chunk, int index) => (chunk << TriangleChunk.IndexBits) | index;
}
