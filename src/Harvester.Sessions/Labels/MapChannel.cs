using Harvester.Sessions.Files;
using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>A channel that has one map for each frame, a PNG image, and is switched on by its name.</summary>
/// <param name="key">Its field in a label and its option in session.json; its folder has hyphens between the words.</param>
/// <param name="fileKind">What a map is, in messages.</param>
/// <param name="bitsPerPixel">Bits per pixel of a map.</param>
/// <param name="ownSwitch">How a user switches it on.</param>
public sealed class MapChannel(string key, string fileKind, int bitsPerPixel, ChannelSwitch ownSwitch) : FrameChannel
{
    /// <inheritdoc />
    public override string Key => key;

    /// <inheritdoc />
    public override string FileKind => fileKind;

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [HyphenatedName.Of(key)];

    /// <inheritdoc />
    public override string RaysKey => key;

    /// <inheritdoc />
    public override ChannelSwitch Switch => ownSwitch;

    /// <inheritdoc />
    public override int? BitsPerPixel => bitsPerPixel;

    /// <summary>Path of a map.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public string PathOf(int frame, string? view) => FramePaths.Map(Folders[0], frame, view);

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<MapLabel>(label => label.Key == key);

    /// <inheritdoc />
    public override IChannelLabel Read(IJsonFields frame)
    {
        IJsonFields map = frame.Fields(key);
        return new MapLabel(key, PictureName(map, "file"), map.Name<SemanticsMethod>("method"), map.Integer("raysCast"));
    }

    internal override void Append(JsonText json, IChannelLabel label)
    {
        var map = (MapLabel)label;
        json.BeginObject()
            .Key("file")
            .String(map.File)
            .Key("method")
            .String(JsonName.Of(map.Method))
            .Key("raysCast")
            .Integer(map.RaysCast)
            .EndObject();
    }
}
