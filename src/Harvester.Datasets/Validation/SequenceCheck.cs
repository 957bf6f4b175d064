using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Validation;

/// <summary>Checks consecutive lines: frame numbers and times increase, and an id stands for one object.</summary>
internal sealed class SequenceCheck
{
    /// <summary>Times are written with six decimals, seconds.</summary>
    private const double TimeTolerance = 1e-6;

    private readonly Dictionary<int, (ObjectClass Class, string Model)> _objects = [];
    private int _lastFrame = -1;
    private double? _ticksEnd;
    private double _lastTime;
    private long _lastGameFrame;

    public IEnumerable<string> Problems(FrameLabel label)
    {
        if (label.Frame <= _lastFrame)
        {
            yield return $"frame is {label.Frame}, but the previous frame is {_lastFrame}; frame numbers must increase.";
        }

        if (label.TimeSeconds < 0)
        {
            yield return FormattableString.Invariant($"timeSeconds is {label.TimeSeconds}; it must be 0 or more.");
        }
        else if (label.TimeSeconds < _lastTime && label.GameFrame > _lastGameFrame)
        {
            yield return FormattableString.Invariant($"timeSeconds is {label.TimeSeconds}, but was {_lastTime} in the previous frame; ")
                + "it may decrease only if gameFrame does too, after a restart of the game.";
        }

        if (_ticksEnd > label.TimeSeconds && label.GameFrame > _lastGameFrame)
        {
            yield return "the ticks of the previous frame's drive do not end before this frame.";
        }

        _ticksEnd = label.Drive is { Ticks: [.., var end] } ? end.TimeSeconds - TimeTolerance : null;
        (_lastFrame, _lastTime, _lastGameFrame) = (label.Frame, label.TimeSeconds, label.GameFrame);
        var seen = new HashSet<int>();
        foreach (ObjectLabel item in label.Objects)
        {
            if (!seen.Add(item.Id))
            {
                yield return $"two objects have the id {item.Id}.";
            }

            if (!_objects.TryAdd(item.Id, (item.Class, item.Model)) && _objects[item.Id] != (item.Class, item.Model))
            {
                (ObjectClass earlierClass, string earlierModel) = _objects[item.Id];
                yield return $"object {item.Id} is {Describe(item.Class, item.Model)}, but was {Describe(earlierClass, earlierModel)} in "
                    + "an earlier frame.";
            }
        }
    }

    private static string Describe(ObjectClass kind, string model) => $"{JsonName.Of(kind)} '{model}'";
}
