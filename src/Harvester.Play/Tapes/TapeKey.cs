namespace Harvester.Play.Tapes;

/// <summary>A key of the keyboard that the settings use.</summary>
/// <param name="Key">Its code in Windows.</param>
/// <param name="IsDown">Whether it was pressed; otherwise it was released.</param>
public sealed record TapeKey(int Key, bool IsDown) : TapeEntry;
