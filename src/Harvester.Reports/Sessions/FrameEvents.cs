using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Sessions;

/// <summary>What happens between two frames and is worth a mark on a timeline.</summary>
internal static class FrameEvents
{
    /// <summary>A car does not move this far between frames; it was repositioned, metres.</summary>
    private const double JumpMetres = 100;

    /// <summary>The events of a frame.</summary>
    /// <param name="before">The frame before it; null for the first.</param>
    /// <param name="now">The frame.</param>
    public static IEnumerable<string> Between(FrameLabel? before, FrameLabel now)
    {
        if (before is null || (now.Moment is { } moment && moment == before.Moment))
        {
            yield break;
        }

        Vector3D moved = now.Ego.Position - before.Ego.Position;
        if (now.Place != before.Place || moved.Length > JumpMetres)
        {
            yield return "new place";
        }

        if (now.Environment.Weather != before.Environment.Weather)
        {
            yield return $"weather: {now.Environment.Weather}";
        }

        if (now.Ego.Motion?.Manoeuvre is { } manoeuvre && manoeuvre != before.Ego.Motion?.Manoeuvre)
        {
            yield return $"manoeuvre: {JsonName.Of(manoeuvre)}";
        }

        foreach (EventMark mark in (now.Events ?? []).Where(mark => before.Events?.Contains(mark) != true))
        {
            yield return FormattableString.Invariant($"event {mark.Id}: {JsonName.Of(mark.Kind)}");
        }

        if (now.Lanes is { } lanes && before.Lanes is { } lanesBefore && lanes.Status != lanesBefore.Status)
        {
            yield return $"lanes: {JsonName.Of(lanes.Status)}";
        }
    }

    /// <summary>The events of successive frames, with the place of each frame among them.</summary>
    public static IEnumerable<(int Index, string Text)> Of(IReadOnlyList<FrameLabel> frames)
    {
        for (int i = 1; i < frames.Count; i++)
        {
            foreach (string text in Between(frames[i - 1], frames[i]))
            {
                yield return (i, text);
            }
        }
    }

    /// <summary>Writes events as a field of the current object.</summary>
    public static void Write(Utf8JsonWriter json, IEnumerable<(int Index, string Text)> events)
    {
        json.WriteStartArray("events");
        foreach ((int index, string text) in events)
        {
            json.WriteStartArray();
            json.WriteNumberValue(index);
            json.WriteStringValue(text);
            json.WriteEndArray();
        }

        json.WriteEndArray();
    }
}
