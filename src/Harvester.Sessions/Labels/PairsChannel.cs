using System.Globalization;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of further pictures of a moment, in the format of the session's images.</summary>
public sealed class PairsChannel : FrameChannel
{
    private const string TimeFormat = @"hh\:mm\:ss";

    /// <inheritdoc />
    public override string Key => "pairs";

    /// <inheritdoc />
    public override string FileKind => "further picture";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [FramePaths.Pairs];

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<PairsLabel>();

    /// <inheritdoc />
    public override IChannelLabel? Read(IJsonFields frame) =>
        frame.List(Key) is { Count: > 0 } pairs ? new PairsLabel([.. pairs.Select(ReadPair)]) : null;

    internal override void Append(JsonText json, IChannelLabel label)
    {
        json.BeginArray();
        foreach (PairLabel pair in ((PairsLabel)label).Pairs)
        {
            json.BeginObject()
                .Key("file")
                .String(pair.File)
                .Key("weather")
                .String(pair.Weather)
                .Key("timeOfDay")
                .String(pair.TimeOfDay.ToString(TimeFormat, CultureInfo.InvariantCulture))
                .Key("without")
                .BeginArray();
            foreach (int id in pair.Without)
            {
                json.Integer(id);
            }

            json.EndArray();
            if (pair.Dropped is { } dropped)
            {
                json.Key("dropped").String(JsonName.Of(dropped));
            }

            json.EndObject();
        }

        json.EndArray();
    }

    private static PairLabel ReadPair(IJsonFields pair)
    {
        string weather = pair.Text("weather");
        string text = pair.Text("timeOfDay");
        TimeSpan time = TimeSpan.TryParseExact(text, TimeFormat, CultureInfo.InvariantCulture, out TimeSpan read)
            ? read
            : throw pair.Refusal($"timeOfDay of pairs must be a time such as 13:05:00, not \"{text}\".");
        string? file = pair.Has("file") ? PictureName(pair, "file") : null;
        PairDrop? dropped = pair.Has("dropped") ? pair.Name<PairDrop>("dropped") : null;
        return file is null == dropped is not null
            ? new PairLabel(file, weather, time, [.. pair.Numbers("without").Select(number => ReadId(pair, number))]) { Dropped = dropped }
            : throw pair.Refusal("A picture of pairs must have either a file or the reason why it was dropped.");
    }

    private static int ReadId(IJsonFields pair, double number) =>
        number is >= 1 and <= ushort.MaxValue && number == Math.Floor(number)
            ? (int)number
            : throw pair.Refusal($"without of pairs must hold ids from 1 to {ushort.MaxValue}.");
}
