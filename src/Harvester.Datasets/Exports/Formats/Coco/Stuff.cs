namespace Harvester.Datasets.Exports.Formats.Coco;

/// <summary>A category of COCO panoptic without instances.</summary>
/// <param name="Category">Id of the category.</param>
/// <param name="Segment">Id of its segment in every image, above the 16-bit ids of objects.</param>
/// <param name="Name">Name of the category.</param>
/// <param name="Colour">Colour to draw it with, 0xRRGGBB.</param>
internal sealed record Stuff(int Category, int Segment, string Name, int Colour)
{
    /// <summary>Posts of signs and traffic lights.</summary>
    public static Stuff Pole { get; } = new(101, 1 << 16, "pole", 0x999999);

    /// <summary>All pixels that show no object.</summary>
    public static Stuff Background { get; } = new(102, 2 << 16, "background", 0x404040);
}
