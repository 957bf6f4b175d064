namespace Harvester.Exports.Formats.Flow;

/// <summary>Where the files of a pair of images are in a dataset of optical flow. A pair has the number of its second image.</summary>
/// <param name="Name">The name of a pair.</param>
/// <param name="First">Path of the first image without its extension, by the name of the pair.</param>
/// <param name="Second">Path of the second image without its extension.</param>
/// <param name="NamesIn">The names of the pairs of a dataset, by their flow.</param>
/// <param name="Maps">The maps of a pair: their paths by its name, and what each is.</param>
internal sealed record FlowLayout(
    Func<int, string> Name,
    Func<string, string> First,
    Func<string, string> Second,
    Func<DatasetContent, IEnumerable<string>> NamesIn,
    IReadOnlyList<(Func<string, string> Path, FlowMapKind Kind)> Maps
)
{
    /// <summary>KITTI 2015: images and flow of 16 bits, once with and once without what is hidden or leaves the picture.</summary>
    public static FlowLayout Kitti { get; } =
        new(
            number => $"{number:D6}",
            name => $"training/image_2/{name}_10",
            name => $"training/image_2/{name}_11",
            dataset => dataset.Files("training/flow_occ").Select(file => Path.GetFileName(file).Split('_')[0]),
            [
                (name => $"training/flow_occ/{name}_10.png", FlowMapKind.All),
                (name => $"training/flow_noc/{name}_10.png", FlowMapKind.Visible),
                (name => $"training/obj_map/{name}_10.png", FlowMapKind.Moved),
            ]
        );

    /// <summary>Middlebury: a folder for each pair, and flow as floating-point numbers.</summary>
    public static FlowLayout Middlebury { get; } =
        new(
            number => $"{number:D6}",
            name => $"other-data/{name}/frame10",
            name => $"other-data/{name}/frame11",
            dataset => dataset.Folders("other-gt-flow").Select(folder => Path.GetFileName(folder)),
            [
                (name => $"other-gt-flow/{name}/flow10.flo", FlowMapKind.Float),
                (name => $"other-masks/{name}/visible10.png", FlowMapKind.VisibleMask),
            ]
        );

    /// <summary>Path of the list of the pairs of a split.</summary>
    public static string ListOf(string split) => $"ImageSets/{split}.txt";
}
