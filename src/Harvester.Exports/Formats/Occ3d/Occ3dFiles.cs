namespace Harvester.Exports.Formats.Occ3d;

/// <summary>Where the files of a dataset are.</summary>
internal static class Occ3dFiles
{
    /// <summary>Folder of the images; each camera has one within it.</summary>
    public const string Images = "imgs";

    /// <summary>What is known of scenes, moments and cameras.</summary>
    public const string Annotations = "annotations.json";

    /// <summary>The first line of <see cref="Annotations"/>: scenes follow, and then the splits.</summary>
    public const string Begin = "{\"scene_infos\":{";

    private const string SplitEnding = "_split";

    /// <summary>Path of the voxels of a moment.</summary>
    /// <param name="scene">Name of its scene.</param>
    /// <param name="token">Its token.</param>
    public static string LabelsOf(string scene, string token) => $"gts/{scene}/{token}/{Occ3dLabels.FileName}";

    /// <summary>The field with the scenes of a split.</summary>
    public static string FieldOf(string split) => split + SplitEnding;
}
