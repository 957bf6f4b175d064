namespace Harvester.Exports.Formats.Columns;

/// <summary>What rows of a frame need besides its label line.</summary>
/// <param name="Frame">Number of the frame over all sessions.</param>
/// <param name="Session">Number of its session.</param>
/// <param name="Split">Its split.</param>
/// <param name="Image">Path of its image in the dataset.</param>
/// <param name="ClassOfObject">The class of the object of an id; null if the object is not exported.</param>
/// <param name="ClassOfRegion">The name in the dataset of a class of an ignore region; null if it is not exported.</param>
internal sealed record TableFrame(
    int Frame,
    int Session,
    string Split,
    string Image,
    Func<int, string?> ClassOfObject,
    Func<string, string?> ClassOfRegion
);
