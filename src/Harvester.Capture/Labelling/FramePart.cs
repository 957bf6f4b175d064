using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>What a channel has found in a frame, until it is written.</summary>
public abstract class FramePart
{
    /// <summary>What the label says of it.</summary>
    public abstract IChannelLabel LabelIn(FrameKey key);

    /// <summary>The contents of the files that the label names, in their order.</summary>
    protected abstract IReadOnlyList<FileContent> Contents { get; }

    /// <summary>Its files in a frame.</summary>
    public IReadOnlyList<FrameFile> FilesIn(FrameKey key) =>
        [.. LabelIn(key).Files.Zip(Contents, static (path, content) => new FrameFile(path, content))];

    /// <summary>A folder that holds its files of this frame alone; null if they lie beside those of other frames.</summary>
    internal virtual string? FolderIn(FrameKey key) => null;

    /// <summary>Takes from the picture of the frame, once it is drawn, what only that shows.</summary>
    internal virtual void Complete(InstanceMap? mask, PixelBuffer picture) { }

    /// <summary>A map as 16-bit greyscale.</summary>
    protected static FileContent Grey16(InstanceMap map) => (stream, png) => png.Write(map, stream);

    /// <summary>A map of values up to 255 as 8-bit greyscale.</summary>
    protected static FileContent Grey8(InstanceMap map) => (stream, png) => png.WriteGrey8(map, stream);

    /// <summary>Bytes as they are.</summary>
    protected static FileContent Bytes(byte[] bytes) => (stream, _) => stream.Write(bytes, 0, bytes.Length);
}
