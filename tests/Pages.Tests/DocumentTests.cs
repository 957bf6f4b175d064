using System.Text;
using System.Xml.Linq;

namespace Harvester.Pages.Tests;

public sealed class DocumentTests
{
    [Fact]
    public void Page_has_title_style_and_body_and_refers_to_no_file()
    {
        string page = Written(stream => HtmlPage.Write(stream, "<a> & b", "b { color: red; }\n", body => body.Element("h1", "<a>")));

        Assert.StartsWith("<!DOCTYPE html>\n<html lang=\"en\">\n", page, StringComparison.Ordinal);
        XElement root = XDocument.Parse(page).Root!;
        Assert.Equal("<a> & b", root.Element("head")!.Element("title")!.Value);
        Assert.Contains("b { color: red; }", root.Element("head")!.Element("style")!.Value, StringComparison.Ordinal);
        Assert.Equal("<a>", root.Element("body")!.Element("h1")!.Value);
        Assert.DoesNotContain("url(", page, StringComparison.Ordinal);
        Assert.DoesNotContain(root.DescendantsAndSelf().Attributes(), attribute => attribute.Name.LocalName is "src" or "href");
    }

    [Fact]
    public void Svg_image_has_its_namespace_and_size()
    {
        XElement root = XDocument
            .Parse(Written(stream => SvgImage.Write(stream, 30, 20, svg => svg.Start("g").Start("line").End().End())))
            .Root!;

        Assert.All(root.DescendantsAndSelf(), element => Assert.Equal("http://www.w3.org/2000/svg", element.Name.NamespaceName));
        Assert.Equal(
            ("0 0 30 20", "30", "20"),
            (root.Attribute("viewBox")!.Value, root.Attribute("width")!.Value, root.Attribute("height")!.Value)
        );
        Assert.Equal(["rect", "g", "line"], root.Descendants().Select(element => element.Name.LocalName));
    }

    [Fact]
    public void Documents_are_utf8_without_byte_order_mark()
    {
        using var stream = new MemoryStream();
        SvgImage.Write(stream, 1, 1, svg => svg.Element("text", "²"));

        Assert.Equal((byte)'<', stream.ToArray()[0]);
        Assert.Contains("²", Encoding.UTF8.GetString(stream.ToArray()), StringComparison.Ordinal);
    }

    private static string Written(Action<Stream> write)
    {
        using var stream = new MemoryStream();
        write(stream);
        return Encoding.UTF8.GetString(stream.ToArray());
    }
}
