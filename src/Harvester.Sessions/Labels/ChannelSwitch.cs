using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The switch of a channel, in the settings of the mod and on the command line.</summary>
/// <param name="Name">
/// Its name in the settings, such as Depth or DistanceBands; on the command line in lower case, with a hyphen between words: --depth,
/// --distance-bands.
/// </param>
/// <param name="Output">What it writes.</param>
public sealed record ChannelSwitch(string Name, string Output)
{
    /// <summary>Its name on the command line.</summary>
    public string Option => "--" + HyphenatedName.Of(Name);
}
