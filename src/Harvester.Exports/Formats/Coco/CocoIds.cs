namespace Harvester.Exports.Formats.Coco;

/// <summary>The ids of annotations.</summary>
internal static class CocoIds
{
    /// <summary>Ids of ignore regions begin above all object ids.</summary>
    public const int FirstRegion = 1 << 16;

    /// <summary>Object ids have 16 bits, so frame and object give an annotation id that does not depend on filters and shards.</summary>
    private const long IdsPerFrame = 1 << 17;

    /// <summary>The id of the annotation of an object, or of a region, of a frame.</summary>
    public static long Of(ExportFrame frame, int id) => (frame.Index * IdsPerFrame) + id;
}
