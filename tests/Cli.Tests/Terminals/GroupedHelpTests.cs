using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Terminals;

public sealed class GroupedHelpTests
{
    [Fact]
    public void Wrapped_description_stays_with_its_option()
    {
        const string help =
            "Usage:\n  x [options]\n\nOptions:\n  --a <N>     First\n              line\n  -?, --help  Help\n" + "  --b         Second\n\n";

        Assert.Equal(
            "Usage:\n  x [options]\n\nLast:\n  --b         Second\n\nFirst:\n  --a <N>     First\n              line\n\n"
                + "General:\n  -?, --help  Help\n\n",
            GroupedHelp.Of(help, [new("Last", ["--b"]), new("First", ["--a"])])
        );
    }
}
