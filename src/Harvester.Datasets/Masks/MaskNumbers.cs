namespace Harvester.Datasets.Masks;

/// <summary>What the numbers in another tool's maps mean.</summary>
public enum MaskNumbers
{
    /// <summary>The ids of the labels, that of a whole object or of a part of it; any other number is an error.</summary>
    Ids,

    /// <summary>The tool's own: each is matched with the object whose cuboid its pixels cover best; the others are no object.</summary>
    Overlap,
}
