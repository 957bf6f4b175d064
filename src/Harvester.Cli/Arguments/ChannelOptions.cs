using System.CommandLine;
using Harvester.Capture.Labelling;
using Harvester.Sessions.Labels;

namespace Harvester.Cli.Arguments;

/// <summary>The options that switch on channels, one for each channel with a switch.</summary>
internal sealed class ChannelOptions
{
    private readonly List<(string Key, Option<bool> Option)> _options =
    [
        .. Switched.Select(channel => (channel.Key, OptionOf(channel.Switch!))),
    ];

    private static IEnumerable<FrameChannel> Switched => FrameChannels.All.Where(channel => channel.Switch is not null);

    private static Option<bool> OptionOf(ChannelSwitch of) => new(of.Option) { Description = $"Also write {of.Output}" };

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command) => _options.ForEach(each => command.Options.Add(each.Option));

    /// <summary>The keys of the channels that are on.</summary>
    public ChannelKeys Keys(ParseResult parsed) => new(_options.Where(each => parsed.GetValue(each.Option)).Select(each => each.Key));
}
