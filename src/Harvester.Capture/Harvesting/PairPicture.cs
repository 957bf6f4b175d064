using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>A further picture of a moment, in its file's format.</summary>
/// <param name="Name">What it shows, as the name of its file without the ending.</param>
/// <param name="Weather">The weather.</param>
/// <param name="TimeOfDay">The time of day.</param>
/// <param name="Without">Ids of the hidden objects, in ascending order.</param>
internal sealed record PairPicture(string Name, string Weather, TimeSpan TimeOfDay, IReadOnlyList<int> Without)
{
    /// <summary>Its place among the pictures of the moment: they are listed by sky, and those of a sky by the objects hidden.</summary>
    public int Place { get; init; }

    /// <summary>The bytes of its file, which another thread makes; null if there is no picture.</summary>
    public Task<byte[]>? Content { get; init; }

    /// <summary>Why there is no picture; null if there is one.</summary>
    public PairDrop? Dropped { get; init; }

    /// <summary>Its label in a frame.</summary>
    public PairLabel Label(int frame, ImageFormat format) =>
        new(Content is null ? null : FramePaths.Pair(frame, Name, format), Weather, TimeOfDay, Without) { Dropped = Dropped };
}
