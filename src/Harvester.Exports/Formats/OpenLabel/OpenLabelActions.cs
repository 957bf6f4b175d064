using System.Globalization;
using Harvester.Sessions.Events;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.OpenLabel;

/// <summary>The events as actions, with the frames in which they are open.</summary>
internal static class OpenLabelActions
{
    private const char Separator = '\t';

    /// <summary>The actions of a frame as a part.</summary>
    public static string PartOf(int frame, IEnumerable<EventMark> marks) =>
        string.Join(
            Separator,
            marks.SelectMany(mark => new[] { Numbers.Text(mark.Id), JsonName.Of(mark.Kind) }).Prepend(Numbers.Text(frame))
        );

    /// <summary>Writes the list of the actions.</summary>
    /// <param name="writer">Where to.</param>
    /// <param name="parts">The parts of the frames.</param>
    public static void Write(TextWriter writer, IEnumerable<string> parts)
    {
        var actions = new SortedDictionary<int, (string Kind, FrameIntervals Frames)>();
        foreach (string part in parts)
        {
            string[] words = part.Split(Separator);
            int frame = NumberOf(words[0]);
            for (int i = 1; i + 1 < words.Length; i += 2)
            {
                int id = NumberOf(words[i]);
                if (!actions.TryGetValue(id, out (string Kind, FrameIntervals Frames) known))
                {
                    known = (words[i + 1], new FrameIntervals());
                    actions.Add(id, known);
                }

                known.Frames.Add(frame);
            }
        }

        writer.Write(
            string.Join(
                ",",
                actions.Select(action =>
                    FormattableString.Invariant($"\"{action.Key}\":{{\"name\":\"{action.Key}\",\"type\":\"{action.Value.Kind}\",")
                    + $"\"frame_intervals\":{action.Value.Frames}}}"
                )
            )
        );
    }

    private static int NumberOf(string word) =>
        int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            ? number
            : throw new DatasetFormatException(
                $"A journal of the export has '{word}', which is not the number of an event. Delete the folder and export again."
            );
}
