namespace Harvester.Runs.Sheets;

/// <summary>What the tiles of one column of a contact sheet have in common.</summary>
/// <param name="Weather">Name of the weather, as in the game.</param>
/// <param name="TimeOfDay">Time of day, which stands still.</param>
/// <param name="Seconds">How long the ego has driven, seconds.</param>
public sealed record SheetMoment(string Weather, TimeSpan TimeOfDay, double Seconds);
