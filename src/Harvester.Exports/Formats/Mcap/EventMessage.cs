using Google.Protobuf;
using Harvester.Sessions.Events;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>The message of the events that are open at a frame.</summary>
internal static class EventMessage
{
    /// <summary>Writes the message.</summary>
    public static byte[] Of(IReadOnlyList<EventMark> marks, long nanoseconds)
    {
        var message = new Gtaharvest.OpenEvents { Timestamp = MessageTime.Of(nanoseconds) };
        message.Id.AddRange(marks.Select(mark => (uint)mark.Id));
        message.Kind.AddRange(marks.Select(mark => JsonName.Of(mark.Kind)));
        return message.ToByteArray();
    }
}
