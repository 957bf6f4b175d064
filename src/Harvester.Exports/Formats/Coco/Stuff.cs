using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Coco;

/// <summary>A category of COCO panoptic without instances.</summary>
/// <param name="Category">Id of the category.</param>
/// <param name="Segment">Id of its segment in every image, above the 16-bit ids of objects.</param>
/// <param name="Name">Name of the category.</param>
/// <param name="Colour">Colour to draw it with, 0xRRGGBB.</param>
internal sealed record Stuff(int Category, int Segment, string Name, int Colour)
{
    /// <summary>Posts of signs and traffic lights.</summary>
    public static Stuff Pole { get; } = new(101, 1 << 16, "pole", 0x999999);

    /// <summary>All pixels that show no object, in datasets without class maps.</summary>
    public static Stuff Background { get; } = new(102, 2 << 16, "background", 0x404040);

    /// <summary>The classes of class maps that are no objects.</summary>
    public static IReadOnlyList<Stuff> Surfaces { get; } =
    [
        Pole,
        Surface(103, SemanticClass.Road),
        Surface(104, SemanticClass.Pavement),
        Surface(105, SemanticClass.LaneMarking),
        Surface(106, SemanticClass.Building),
        Surface(107, SemanticClass.Vegetation),
        Surface(108, SemanticClass.Terrain),
        Surface(109, SemanticClass.Sky),
        Surface(110, SemanticClass.Water),
        Surface(111, SemanticClass.Fence),
    ];

    /// <summary>The segment of a class; 0, void, for objects and the unknown.</summary>
    public static int SegmentOf(SemanticClass kind)
    {
        string name = JsonName.Of(kind);
        return Surfaces.FirstOrDefault(stuff => stuff.Name == name)?.Segment ?? 0;
    }

    private static Stuff Surface(int category, SemanticClass kind)
    {
        (byte red, byte green, byte blue) = SemanticClasses.ColourOf(kind);
        return new Stuff(category, (category - 100) << 16, JsonName.Of(kind), (red << 16) | (green << 8) | blue);
    }
}
