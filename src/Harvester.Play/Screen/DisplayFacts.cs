namespace Harvester.Play.Screen;

/// <summary>How a window is displayed.</summary>
/// <param name="Dpi">Dots per inch of its monitor, 96 for a scaling of 100 %; null where Windows does not tell.</param>
/// <param name="IsExclusive">Whether a program runs in exclusive full screen.</param>
internal readonly record struct DisplayFacts(int? Dpi, bool IsExclusive);
