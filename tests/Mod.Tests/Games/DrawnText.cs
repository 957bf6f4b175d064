namespace Harvester.Mod.Tests.Games;

/// <summary>A line of text over the picture.</summary>
/// <param name="Text">The line.</param>
/// <param name="Left">Its left end, fraction of the window.</param>
/// <param name="Top">Its upper edge, fraction of the window.</param>
internal sealed record DrawnText(string Text, double Left, double Top);
