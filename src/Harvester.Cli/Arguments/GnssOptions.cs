using System.CommandLine;
using Harvester.Runs.Faults;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;

namespace Harvester.Cli.Arguments;

/// <summary>The noise of the satellite receiver.</summary>
internal sealed class GnssOptions
{
    private Option<string?> Noise { get; } =
        new("--gnss-noise")
        {
            Description = $"Noise of the satellite receiver: {GnssNoise.Form}, m, m/√s and m/s [default: none]",
            HelpName = "A=N,B=N",
        };

    public void AddTo(Command command) => command.Options.Add(Noise);

    /// <summary>The noise; null for an ideal receiver.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="isOn">Whether the harvest has a receiver.</param>
    /// <param name="seed">The seed of the harvest.</param>
    /// <exception cref="UsageException">The text is not a noise specification, or there is no receiver.</exception>
    public GnssNoise? Parse(ParseResult parsed, bool isOn, int seed) =>
        parsed.GetValue(Noise) is not { } text ? null
        : !isOn ? throw new UsageException($"{Noise.Name} needs {FrameChannels.Gnss.Switch.Option}.")
        : GnssNoise.Parse(text) is not { } noise
            ? throw new UsageException($"{Noise.Name} takes a comma-separated list of {GnssNoise.Form}, {GnssNoise.Limits}, not '{text}'.")
        : noise with { Seed = seed };
}
