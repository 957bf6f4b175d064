using System.Text;
using System.Text.Json;
using System.Xml.Linq;
using Harvester.Geometry;

namespace Harvester.Pages.Tests;

public sealed class MarkupWriterTests
{
    // Ends elements and attributes, looks like entities, and is not all ASCII.
    private const string Hostile = "</td><script>alert(1)</script> \" ' onload='x' &amp; &#x3c; ]]> <!-- ü 車 😀";

    [Fact]
    public void Hostile_text_and_attributes_are_read_back_unchanged()
    {
        string written = Written(svg => svg.Start("text").With("id", Hostile).Text(Hostile).End());

        XElement text = Assert.Single(XDocument.Parse(written).Root!.Elements(), element => element.Name.LocalName == "text");
        Assert.Equal((Hostile, Hostile), (text.Attribute("id")!.Value, text.Value));
        Assert.DoesNotContain("<script", written, StringComparison.Ordinal);
    }

    // U+FFFE is no character of XML; the others are a control character, NUL and halves of a surrogate pair.
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(0xFFFE)]
    [InlineData(0xD83D)]
    [InlineData(0xDE00)]
    public void Characters_that_no_markup_may_hold_are_replaced(int character)
    {
        string name = $"a{(char)character}b";
        string written = Written(svg => svg.Start("text").With("id", name).Text(name).End());

        XElement text = XDocument.Parse(written).Root!.Elements().Last();
        Assert.Equal(("a\uFFFDb", "a\uFFFDb"), (text.Attribute("id")!.Value, text.Value));
    }

    [Fact]
    public void Empty_elements_of_html_keep_their_end_tag()
    {
        string page = Page(body => body.Start("td").End().Start("img").End().Start("svg").Start("path").End().End().Start("p").End());

        Assert.Contains("<td></td><img /><svg><path /></svg><p></p>", page, StringComparison.Ordinal);
    }

    [Fact]
    public void Numbers_are_rounded_and_independent_of_the_culture()
    {
        string written = Written(svg =>
        {
            svg.Start("path").With("x", -0.04).With("y", 1234.56).With("z", 2.675, 2);
            svg.WithLines([
                    [new Vector2D(0, 1), new Vector2D(2.25, -3)],
                    [new Vector2D(4, 5)],
                ])
                .End();
            svg.Start("polygon").WithPoints([new Vector2D(0, 1), new Vector2D(2.25, -3)]).End();
        });

        // Halves are rounded away from zero.
        Assert.Contains("<path x=\"0\" y=\"1234.6\" z=\"2.68\" d=\"M0 1L2.3 -3M4 5\" />", written, StringComparison.Ordinal);
        Assert.Contains("<polygon points=\"0,1 2.3,-3\" />", written, StringComparison.Ordinal);
    }

    [Fact]
    public void Files_are_embedded_as_base64()
    {
        byte[] content = [.. Enumerable.Range(0, 1000).Select(i => (byte)i)];

        string page = Page(body => body.Start("img").WithData("src", "image/png", content).End().Start("p").Base64(content).End());

        string base64 = Convert.ToBase64String(content);
        Assert.Contains($"<img src=\"data:image/png;base64,{base64}\" /><p>{base64}</p>", page, StringComparison.Ordinal);
    }

    [Fact]
    public void Json_cannot_end_its_script_element()
    {
        string page = Page(body =>
            body.Json(
                "data",
                json =>
                {
                    json.WriteStartArray();
                    json.WriteStringValue(Hostile);
                    json.WriteEndArray();
                }
            )
        );

        string data = page.Split("id=\"data\">")[1].Split("</script>")[0];
        Assert.Equal(Hostile, JsonDocument.Parse(data).RootElement[0].GetString());
    }

    [Theory]
    [InlineData("style", "</style>")]
    [InlineData("script", "if (a </SCRIPT")]
    public void Code_with_the_end_tag_of_its_element_is_an_error(string element, string code) =>
        Assert.Throws<ArgumentException>(() => Page(body => body.Code(element, code)));

    private static string Written(Action<MarkupWriter> write)
    {
        using var stream = new MemoryStream();
        SvgImage.Write(stream, 10, 20, write);
        return Encoding.UTF8.GetString(stream.ToArray());
    }

    private static string Page(Action<MarkupWriter> write)
    {
        using var stream = new MemoryStream();
        HtmlPage.Write(stream, "title", "", write);
        return Encoding.UTF8.GetString(stream.ToArray());
    }
}
