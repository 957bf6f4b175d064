using System.Text.Json;

namespace Harvester.Sessions.Reading.Json;

/// <summary>What is wrong with a text that is not JSON, in the one style of all messages.</summary>
public static class JsonFault
{
    /// <summary>The fault of a text whose line is named already, or that has one line only.</summary>
    public static string InLine(JsonException fault) =>
        FormattableString.Invariant($"invalid JSON at byte {fault.BytePositionInLine + 1}.");

    /// <summary>The fault of a text of several lines, or what the message of another error says of it.</summary>
    public static string InText(Exception fault) => fault is JsonException json ? InText(json) : fault.Message;

    /// <summary>The fault of a line, or what the message of another error says of it.</summary>
    public static string InLine(Exception fault) => fault is JsonException json ? InLine(json) : fault.Message;

    /// <summary>The fault of a text of several lines.</summary>
    public static string InText(JsonException fault) =>
        FormattableString.Invariant($"invalid JSON at line {fault.LineNumber + 1}, byte {fault.BytePositionInLine + 1}.");
}
