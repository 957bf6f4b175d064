using System.Diagnostics;
using Harvester.Cli.Viewing;

namespace Harvester.Cli.Tests.Viewing;

public sealed class AddressFileTests
{
    private const string Token = "0123456789abcdef";

    private static readonly Uri Address = new($"http://127.0.0.1:8080/{Token}/0/");

    [Fact]
    public void File_leads_to_the_address()
    {
        using AddressFile file = AddressFile.Create(Address);

        Assert.Contains($"http-equiv=\"refresh\" content=\"0; url={Address}\"", File.ReadAllText(file.Path), StringComparison.Ordinal);
    }

    [Fact]
    public void Only_the_user_can_read_the_file()
    {
        using AddressFile file = AddressFile.Create(Address);
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        Assert.Equal(UnixFileMode.UserRead | UnixFileMode.UserWrite, File.GetUnixFileMode(file.Path));
        Assert.Equal(
            UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute,
            File.GetUnixFileMode(Path.GetDirectoryName(file.Path)!)
        );
    }

    [Fact]
    public void Arguments_of_the_browser_lack_the_token()
    {
        using AddressFile file = AddressFile.Create(Address);

        ProcessStartInfo start = DefaultBrowser.StartOf(file);

        Assert.DoesNotContain(start.ArgumentList.Append(start.FileName), word => word.Contains(Token, StringComparison.Ordinal));
    }

    [Fact]
    public void File_is_removed_with_its_folder()
    {
        AddressFile file = AddressFile.Create(Address);
        file.Dispose();

        Assert.False(Directory.Exists(Path.GetDirectoryName(file.Path)));
    }
}
