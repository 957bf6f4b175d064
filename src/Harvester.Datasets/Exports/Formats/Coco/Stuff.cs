namespace Harvester.Datasets.Exports.Formats.Coco;

/// <summary>A category of COCO panoptic without instances.</summary>
/// <param name="Category">Its number among the categories.</param>
/// <param name="Segment">The number of its segment in every image, above those of objects, which fit 16 bits.</param>
/// <param name="Name">Its name.</param>
/// <param name="Colour">A colour to draw it with, 0xRRGGBB.</param>
internal sealed record Stuff(int Category, int Segment, string Name, int Colour)
{
    /// <summary>Posts of signs and traffic lights.</summary>
    public static Stuff Pole { get; } = new(101, 1 << 16, "pole", 0x999999);

    /// <summary>Everything that is not an object.</summary>
    public static Stuff Background { get; } = new(102, 2 << 16, "background", 0x404040);
}
