namespace Harvester.Play.Tapes;

/// <summary>A fact about the recording: a version, or the text of a file that the mod reads.</summary>
/// <param name="Name">One of <see cref="TapeFacts"/>.</param>
/// <param name="Text">Its value.</param>
public sealed record TapeFact(string Name, string Text) : TapeEntry;
