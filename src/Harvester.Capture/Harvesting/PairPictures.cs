using Harvester.Capture.Labelling;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>The further pictures of a frame's moment.</summary>
/// <param name="pictures">The pictures, and those that are missing.</param>
internal sealed class PairPictures(IReadOnlyList<PairPicture> pictures) : FramePart
{
    /// <summary>The contents of the files. Another thread encodes them; the caller waits until it has.</summary>
    protected override IReadOnlyList<FileContent> Contents => [.. Tasks.Select(static task => Bytes(task.GetAwaiter().GetResult()))];

    private IEnumerable<Task<byte[]>> Tasks => pictures.Select(picture => picture.Content).OfType<Task<byte[]>>();

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) =>
        new PairsLabel([.. pictures.Select(picture => picture.Label(key.Frame, key.Format))]);

    internal override string? FolderIn(FrameKey key) => Tasks.Any() ? FramePaths.PairsOf(key.Frame) : null;
}
