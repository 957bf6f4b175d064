namespace Harvester.Datasets.Masks;

/// <summary>The meaning of the values in another tool's maps.</summary>
public enum MaskNumbers
{
    /// <summary>Ids of labels, of whole objects or of parts; any other value is an error.</summary>
    Ids,

    /// <summary>Arbitrary numbers: each is matched with the object whose cuboid it overlaps most, if any.</summary>
    Overlap,
}
