using Harvester.Sessions.Files;
using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of class maps: 8-bit greyscale PNG images with a class for each pixel.</summary>
public sealed class ClassMapChannel : FrameChannel
{
    /// <inheritdoc />
    public override string Key => "classMap";

    /// <inheritdoc />
    public override string FileKind => "class map";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [FramePaths.ClassMaps];

    /// <inheritdoc />
    public override string RaysKey => "classes";

    /// <inheritdoc />
    public override int? BitsPerPixel => 8;

    /// <inheritdoc />
    public override bool OutlivesLens(IChannelLabel label) => label is ClassMapLabel { Method: SemanticsMethod.Exact };

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<ClassMapLabel>();

    /// <inheritdoc />
    public override IChannelLabel Read(IJsonFields frame)
    {
        IJsonFields map = frame.Fields(Key);
        return new ClassMapLabel(
            PictureName(map, "file"),
            map.Name<SemanticsMethod>("method"),
            map.Integer("raysCast"),
            map.Integer("interpolatedPixels")
        );
    }

    internal override void Append(JsonText json, IChannelLabel label)
    {
        var classes = (ClassMapLabel)label;
        json.BeginObject()
            .Key("file")
            .String(classes.File)
            .Key("method")
            .String(JsonName.Of(classes.Method))
            .Key("raysCast")
            .Integer(classes.RaysCast)
            .Key("interpolatedPixels")
            .Integer(classes.InterpolatedPixels)
            .EndObject();
    }
}
