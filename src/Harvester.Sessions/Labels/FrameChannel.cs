using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>
/// An output of frames that has files of its own: how it is named, written and read. Its production is a channel of Harvester.Capture.
/// </summary>
public abstract class FrameChannel
{
    /// <summary>The field of a label that holds what the channel says.</summary>
    public abstract string Key { get; }

    /// <summary>What one of its files is, in messages.</summary>
    public abstract string FileKind { get; }

    /// <summary>The folders of a session that hold its files.</summary>
    public abstract IReadOnlyList<string> Folders { get; }

    /// <summary>The field of <c>rays</c> that counts its rays; null if they are not counted.</summary>
    public virtual string? RaysKey => null;

    /// <summary>How a user switches it on; null if other options decide.</summary>
    public virtual ChannelSwitch? Switch => null;

    /// <summary>Bits per pixel of its maps, which have the size of the frame's image; null if its files are others.</summary>
    public virtual int? BitsPerPixel => null;

    /// <summary>Bits per pixel of one of its maps, which have the size of the frame's image; null if the file is another.</summary>
    /// <param name="label">What the channel says.</param>
    /// <param name="file">The path of the map in it.</param>
    public virtual int? BitsOf(IChannelLabel label, string file) => BitsPerPixel;

    /// <summary>The size of its maps, pixels; that of the frame's image unless the channel says otherwise.</summary>
    /// <param name="label">What the channel says.</param>
    /// <param name="camera">The camera of the frame.</param>
    public virtual (int Width, int Height) SizeOf(IChannelLabel label, CameraLabel camera) =>
        camera is null ? throw new ArgumentNullException(nameof(camera)) : (camera.Width, camera.Height);

    /// <summary>What the channel says in a frame; null if the frame does not have it.</summary>
    public abstract IChannelLabel? LabelIn(ChannelLabels labels);

    /// <summary>
    /// Whether what a harvest found still holds when labels are recomputed with another lens. Maps were made through that of the harvest.
    /// </summary>
    /// <param name="label">What the channel says.</param>
    public virtual bool OutlivesLens(IChannelLabel label) => BitsPerPixel is null;

    /// <summary>Reads what the channel says from the fields of a label that has its key.</summary>
    /// <param name="frame">The fields of the label.</param>
    /// <returns>What it says; null if that is nothing.</returns>
    public abstract IChannelLabel? Read(IJsonFields frame);

    /// <summary>Writes the value of its key.</summary>
    internal abstract void Append(JsonText json, IChannelLabel label);

    /// <summary>The name of a picture in a field; that of another file of the session, such as labels.jsonl, is refused.</summary>
    protected static string PictureName(IJsonFields fields, string field) => FileNames.Picture(fields, field);
}
