using System.Collections.Generic;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;

namespace Harvester.Datasets.Validation;

/// <summary>What must hold from line to line: rising frame numbers, and object numbers that mean one object.</summary>
internal sealed class SequenceCheck
{
    private readonly Dictionary<int, (ObjectClass Class, string Model)> _objects = [];
    private int _lastFrame = -1;

    public IEnumerable<string> Problems(FrameLabel label)
    {
        if (label.Frame <= _lastFrame)
        {
            yield return $"frame is {label.Frame}, but the numbers must rise and {_lastFrame} came before.";
        }

        _lastFrame = label.Frame;
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
                yield return $"object {item.Id} is {Describe(item.Class, item.Model)}, but was {Describe(earlierClass, earlierModel)} in an earlier frame.";
            }
        }
    }

    private static string Describe(ObjectClass kind, string model) => $"{JsonName.Of(kind)} '{model}'";
}
