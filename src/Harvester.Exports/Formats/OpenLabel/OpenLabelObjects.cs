using System.Globalization;
using System.Text.Json;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.OpenLabel;

/// <summary>The end of a file: its frames, the context, and the objects with the frames in which they occur.</summary>
internal static class OpenLabelObjects
{
    private const char Separator = '\t';

    /// <summary>The objects of a frame as a part.</summary>
    public static string PartOf(int frame, IEnumerable<(int Id, string Type)> objects) =>
        string.Join(
            Separator,
            objects.SelectMany(item => new[] { Numbers.Text(item.Id), JsonSerializer.Serialize(item.Type) }).Prepend(Numbers.Text(frame))
        );

    /// <summary>Writes the end up to the last object.</summary>
    /// <param name="writer">Where to.</param>
    /// <param name="parts">The parts of the frames.</param>
    public static void Write(TextWriter writer, IEnumerable<string> parts)
    {
        var all = new FrameIntervals();
        var objects = new SortedDictionary<int, (string Type, FrameIntervals Frames)>();
        foreach (string part in parts)
        {
            string[] words = part.Split(Separator);
            int frame = NumberOf(words[0]);
            all.Add(frame);
            for (int i = 1; i + 1 < words.Length; i += 2)
            {
                int id = NumberOf(words[i]);
                if (!objects.TryGetValue(id, out (string Type, FrameIntervals Frames) known))
                {
                    known = (words[i + 1], new FrameIntervals());
                    objects.Add(id, known);
                }

                known.Frames.Add(frame);
            }
        }

        writer.Write($"\"frame_intervals\":{all},\"contexts\":{{\"0\":{{\"name\":\"environment\",\"type\":\"environment\"}}}},");
        writer.Write("\"objects\":{\n");
        writer.Write(string.Join(",\n", objects.Select(item => Text(item.Key, item.Value.Type, item.Value.Frames))));
    }

    /// <summary>An object of the list of objects.</summary>
    /// <param name="id">Its number.</param>
    /// <param name="type">Its type as JSON.</param>
    /// <param name="frames">The frames in which it occurs.</param>
    public static string Text(int id, string type, FrameIntervals frames) =>
        FormattableString.Invariant($"\"{id}\":{{\"name\":\"{id}\",\"type\":{type},\"frame_intervals\":{frames}}}");

    private static int NumberOf(string word) =>
        int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            ? number
            : throw new DatasetFormatException(
                $"A journal of the export has '{word}', which is not the number of an object. Delete the folder and export again."
            );
}
